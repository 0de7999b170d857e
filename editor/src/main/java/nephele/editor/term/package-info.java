/** The names of fields, kinds, sections and choices of level records, in the languages of the editor. */
package nephele.editor.term;
