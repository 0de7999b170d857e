/**
 * Edits on disk before they are saved. A {@link nephele.editor.save.journal.Journal} appends each edit within two seconds
 * to a log of its own; after a crash a {@link nephele.editor.save.journal.JournalFolder} finds what was not saved. A torn
 * end of a log costs the last edit only.
 */
package nephele.editor.save.journal;
