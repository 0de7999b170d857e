/** Texture placement on the faces of solids: fitting, aligning, locking and continuing. */
package nephele.editor.paint;
