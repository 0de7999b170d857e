/**
 * The texts of the editor in English, Brazilian and European Portuguese: words, names of fields, kinds and choices, and
 * the limits of numbers.
 */
package nephele.editor.text;
