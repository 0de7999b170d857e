/**
 * The levels that a viewport draws instead of the document's: without what is hidden or broken, and with other light
 * and materials for each view mode. Records that follow from unchanged records are the same objects.
 */
package nephele.editor.draw.derived;
