/** What the window shows of proofs beside the viewport: the explanation of a pixel and the page of a report. */
package nephele.editor.window.proving;
