/** The models of the editor's panels, without Swing: queries, rows, fields, and entries of the palette. */
package nephele.editor.panel.model;
