/** Finds levels by what a user types: files, else the levels in the jar. */
package nephele.app.levels;
