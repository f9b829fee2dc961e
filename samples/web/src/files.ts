// Files that the visitor takes away or brings. Nothing leaves the machine.

/** Offers a text for saving. */
export function save(name: string, type: string, text: string): void {
  const link = document.createElement("a"), url = URL.createObjectURL(new Blob([text], { type }));
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Calls back with a file that is chosen in `input`, or dropped anywhere on the page. */
export function onFile(input: HTMLInputElement, opened: (file: File) => void): void {
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    if (file) opened(file);
    input.value = "";
  });
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    const file = event.dataTransfer?.files[0];
    if (file) opened(file);
  });
}
