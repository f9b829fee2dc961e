/* Code of the board: an ATmega328P at 16 MHz (Arduino Uno, Nano). README.md lists its pins. */
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <avr/wdt.h>
#include <stddef.h>
#include <util/atomic.h>

#include "samples/app/firmware/plate.h"

/* Fuses, which only a programmer can set: the clock is a crystal, a chip erase keeps the EEPROM, and the chip is reset
 * below 4.3 V, because 16 MHz needs 3.8 V. */
FUSES = {.low = 0xFF, .high = HFUSE_DEFAULT & FUSE_EESAVE, .extended = FUSE_BODLEVEL1 & FUSE_BODLEVEL0};

enum { FRAME_TICKS = 40000 }; /* time between two pulses, 20 ms: timer 1 counts half microseconds */

/* Serial line with 115200 baud, and a ring buffer for each direction. */

enum { RING = 128, RING_MASK = RING - 1 };

static volatile char received[RING];
static volatile uint8_t received_head, received_tail;
static volatile char unsent[RING];
static volatile uint8_t unsent_head, unsent_tail;

ISR(USART_RX_vect) {
  const uint8_t status = UCSR0A;
  char byte = (char)UDR0;
  if ((status & (_BV(FE0) | _BV(DOR0))) != 0) byte = 0; /* makes the line invalid */
  const uint8_t next = (received_head + 1) & RING_MASK;
  if (next == received_tail) return;
  received[received_head] = byte;
  received_head = next;
}

ISR(USART_UDRE_vect) {
  if (unsent_head == unsent_tail) {
    UCSR0B &= (uint8_t)~_BV(UDRIE0);
    return;
  }
  UDR0 = (uint8_t)unsent[unsent_tail];
  unsent_tail = (unsent_tail + 1) & RING_MASK;
}

static void start_serial_line(void) {
  UCSR0A = _BV(U2X0);
  UBRR0 = 16; /* 117647 baud: 2.1 % too fast, as on all boards with 16 MHz */
  UCSR0C = _BV(UCSZ01) | _BV(UCSZ00);
  UCSR0B = _BV(RXEN0) | _BV(TXEN0) | _BV(RXCIE0);
}

static bool send(const char* line, uint8_t length) {
  const uint8_t used = (uint8_t)(unsent_head - unsent_tail) & RING_MASK;
  if (length == 0 || length >= RING - used) return false;
  for (uint8_t i = 0; i < length; ++i) {
    unsent[unsent_head] = line[i];
    unsent_head = (unsent_head + 1) & RING_MASK;
  }
  ATOMIC_BLOCK(ATOMIC_RESTORESTATE) UCSR0B |= _BV(UDRIE0);
  return true;
}

/* Servo pulses. The compare unit sets and clears pin OC1A itself, so that the delay of an interrupt does not move an
 * edge. The interrupt after each edge prepares the next edge, which is at least 500 us later. */

static volatile uint16_t wanted_ticks; /* width of the next pulse, in half microseconds; 0: no pulse */

ISR(TIMER1_COMPA_vect) {
  static uint16_t width_ticks = 0;
  static bool rising = false; /* the edge that caused this interrupt was the start of a pulse */
  if (rising) {
    /* Completes a pulse that has begun, because a shorter pulse would command another angle. */
    if (wanted_ticks != 0) width_ticks = wanted_ticks;
    TCCR1A = _BV(COM1A1); /* the next edge clears the pin */
    OCR1A += width_ticks;
    rising = false;
    return;
  }
  const uint16_t rest_ticks = FRAME_TICKS - width_ticks;
  width_ticks = wanted_ticks;
  rising = width_ticks != 0;
  TCCR1A =
      rising ? _BV(COM1A1) | _BV(COM1A0) : 0; /* the next edge sets the pin; without a pulse, the port keeps it low */
  OCR1A += rest_ticks;
  if (!rising) width_ticks = 0;
}

static void start_pulses(void) {
  DDRB |= _BV(DDB1) | _BV(DDB5);
  OCR1A = FRAME_TICKS;
  TIMSK1 = _BV(OCIE1A);
  TCCR1B = _BV(CS11);
}

static volatile uint8_t ticks; /* milliseconds that the main loop has not processed yet */

ISR(TIMER0_COMPA_vect) {
  if (ticks < 255) ++ticks;
}

static void start_clock(void) {
  TCCR0A = _BV(WGM01);
  OCR0A = 249;
  TIMSK0 = _BV(OCIE0A);
  TCCR0B = _BV(CS01) | _BV(CS00);
}

/* Settings in EEPROM: two copies, so that a power failure during a save leaves one of them complete. */

enum { COPIES = 2, COPY_BYTES = 128 };

static uint8_t to_save[SETTINGS_BYTES];
static uint8_t save_at, save_copy = COPIES;

static uint8_t* eeprom_at(uint8_t copy, uint8_t at) { return (uint8_t*)(uintptr_t)(copy * COPY_BYTES + at); }

static bool load(Settings* settings) {
  for (uint8_t copy = 0; copy < COPIES; ++copy) {
    uint8_t bytes[SETTINGS_BYTES];
    eeprom_read_block(bytes, eeprom_at(copy, 0), sizeof bytes);
    if (settings_unpack(settings, bytes)) return true;
  }
  return false;
}

static void save(const uint8_t bytes[SETTINGS_BYTES]) {
  for (uint8_t i = 0; i < SETTINGS_BYTES; ++i) to_save[i] = bytes[i];
  save_at = 0;
  save_copy = 0;
}

static bool is_saved(void) {
  for (uint8_t copy = 0; copy < COPIES; ++copy)
    for (uint8_t i = 0; i < SETTINGS_BYTES; ++i)
      if (eeprom_read_byte(eeprom_at(copy, i)) != to_save[i]) return false;
  return true;
}

/* Starts to write the next byte, which takes 3.4 ms. The main loop continues meanwhile. */
static void continue_to_save(Plate* plate) {
  if (save_copy == COPIES || !eeprom_is_ready()) return;
  if (save_at < SETTINGS_BYTES) {
    eeprom_update_byte(eeprom_at(save_copy, save_at), to_save[save_at]);
    ++save_at;
    return;
  }
  save_at = 0;
  if (++save_copy == COPIES) plate_saved(plate, is_saved());
}

/* Watchdog. If the main loop hangs for 120 ms, the interrupt ends the pulses; 120 ms later the board is reset. */

ISR(WDT_vect) { wanted_ticks = 0; /* a pulse that has begun is completed */ }

static void start_watchdog(void) {
  wdt_enable(WDTO_120MS);
  WDTCSR |= _BV(WDIE);
}

static void reset_watchdog(void) {
  wdt_reset();
  WDTCSR |= _BV(WDIE); /* the interrupt clears this bit */
}

static void start_inputs(void) {
  PORTD = _BV(PORTD2);
  ADMUX = _BV(REFS0);
  ADCSRA = _BV(ADEN) | _BV(ADIE) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);
}

/* Readings of A0 (sensor) and A1 (half of the servo's supply), converted every millisecond. -1: no reading yet. */
static volatile int16_t readings[2] = {-1, -1};

ISR(ADC_vect) {
  const uint8_t channel = ADMUX & 1;
  readings[channel] = (int16_t)ADC;
  ADMUX = _BV(REFS0) | (channel ^ 1);
  if (channel == 0) ADCSRA |= _BV(ADSC);
}

static const PlateBoard board = {send, save};

static void tick(Plate* plate) {
  PlateInputs inputs = {.emergency_open = (PIND & _BV(PIND2)) != 0};
  ATOMIC_BLOCK(ATOMIC_RESTORESTATE) {
    inputs.adc = readings[0];
    inputs.supply_adc = readings[1];
  }
  ADCSRA |= _BV(ADSC);
  plate_tick(plate, &inputs);
  const uint16_t wanted = plate_pulse_ticks(plate);
  ATOMIC_BLOCK(ATOMIC_RESTORESTATE) wanted_ticks = wanted;
  if (wanted != 0) {
    PORTB |= _BV(PORTB5);
  } else {
    PORTB &= (uint8_t)~_BV(PORTB5);
  }
  continue_to_save(plate);
  reset_watchdog();
}

int main(void) {
  static Plate plate;
  Settings settings;
  MCUSR = 0;
  wdt_disable(); /* the watchdog remains on after it has reset the board */
  plate_start(&plate, &board, load(&settings) ? &settings : NULL);
  start_inputs();
  start_serial_line();
  start_pulses();
  start_clock();
  start_watchdog();
  set_sleep_mode(SLEEP_MODE_IDLE);
  sei();
  for (;;) {
    while (received_tail != received_head) {
      const char byte = received[received_tail];
      received_tail = (received_tail + 1) & RING_MASK;
      plate_receive(&plate, byte);
    }
    uint8_t passed;
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) {
      passed = ticks;
      ticks = 0;
    }
    if (passed > plate.loop_ms) plate.loop_ms = passed;
    for (; passed > 0; --passed) tick(&plate);
    cli();
    if (received_tail == received_head && ticks == 0) {
      sleep_enable();
      sei(); /* the next instruction is executed before any interrupt */
      sleep_cpu();
      sleep_disable();
    }
    sei();
  }
}
