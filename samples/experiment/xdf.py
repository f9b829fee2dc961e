"""Writes XDF 1.0, the format of recordings of the lab streaming layer: streams with their time stamps."""
import struct
from xml.sax.saxutils import escape

import numpy

FILE_HEADER, STREAM_HEADER, SAMPLES, STREAM_FOOTER = 1, 2, 3, 6  # tags of chunks


def _tags(**fields):
    return "".join(f"<{name}>{escape(str(value))}</{name}>" for name, value in fields.items())


def _chunk(tag, content):
    return b"\x08" + struct.pack("<QH", len(content) + 2, tag) + content


def _info(text):
    return b'<?xml version="1.0"?><info>' + text.encode() + b"</info>"


def _samples(times, values):
    """Each with its time: of numbers a row of doubles, of texts one."""
    if values.dtype != object:
        rows = numpy.zeros(len(times), [("time_bytes", "u1"), ("time", "<f8"), ("values", "<f8", values.shape[1])])
        rows["time_bytes"], rows["time"], rows["values"] = 8, times, values
        return rows.tobytes()
    texts = [text.encode() for text in values]
    return b"".join(struct.pack("<BdBI", 8, time, 4, len(text)) + text for time, text in zip(times, texts))


def write(file, streams):
    """`streams`: (name, type, channels as (label, type, unit), times in s, which increase, values: rows of numbers, or texts)."""
    content = [b"XDF:", _chunk(FILE_HEADER, _info(_tags(version="1.0")))]
    for number, (name, kind, channels, times, values) in enumerate(streams, 1):
        described = "".join(f"<channel>{_tags(label=label, type=of, unit=unit)}</channel>" for label, of, unit in channels)
        about = _tags(name=name, type=kind, channel_count=len(channels), nominal_srate=0, created_at=0,
                      channel_format="string" if values.dtype == object else "double64")
        footer = _tags(first_timestamp=times[0], last_timestamp=times[-1], sample_count=len(times))
        stream = struct.pack("<I", number)
        content += [_chunk(STREAM_HEADER, stream + _info(f"{about}<desc><channels>{described}</channels></desc>")),
                    _chunk(SAMPLES, stream + struct.pack("<BQ", 8, len(times)) + _samples(times, values)),
                    _chunk(STREAM_FOOTER, stream + _info(footer))]
    file.write_bytes(b"".join(content))
