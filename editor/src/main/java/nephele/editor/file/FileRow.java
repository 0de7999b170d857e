package nephele.editor.file;

import nephele.editor.text.Words;

/**
 * A line of a list of versions of a level.
 *
 * @param title such as the file's name
 * @param detail such as time and number of edits
 * @param place the whole path of the file; empty for none
 */
public record FileRow(Words title, Words detail, Words place) {}
