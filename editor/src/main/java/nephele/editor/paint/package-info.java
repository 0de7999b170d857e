/** Where pictures lie on the faces of solids: fitting, aligning, keeping and continuing them. */
package nephele.editor.paint;
