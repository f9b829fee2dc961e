// Files that the visitor takes away or brings. Nothing leaves the machine.

/** Offers a text for saving. */
export function save(name: string, type: string, text: string): void {
  const link = document.createElement("a"), url = URL.createObjectURL(new Blob([text], { type }));
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Calls back with files that are chosen in `input`, or dropped anywhere on the page, together. */
export function onFiles(input: HTMLInputElement, opened: (files: readonly File[]) => void): void {
  const take = (files: FileList | null | undefined) => { if (files?.length) opened([...files]); };
  input.addEventListener("change", () => {
    take(input.files);
    input.value = "";
  });
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    take(event.dataTransfer?.files);
  });
}
