/** The parts of the window that show proofs beside the viewport: the explanation of a pixel and the page of a report. */
package nephele.editor.window.proving;
