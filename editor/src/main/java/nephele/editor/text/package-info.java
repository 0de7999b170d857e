/** The texts of the editor in English, Brazilian and European Portuguese. */
package nephele.editor.text;
