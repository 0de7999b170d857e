/** What the panels of the editor show and change, without a window: queries, rows, fields, and entries of the palette. */
package nephele.editor.panel.model;
