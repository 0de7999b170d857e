/** What a user names: levels, their recorded walks, and the viewpoints in them; files come first, then the jar. */
package nephele.engine.named;
