/** How far a picture or a number is from the exact one, and how sure a measured cost is. Uses nothing of ours. */
package nephele.engine.measure;
