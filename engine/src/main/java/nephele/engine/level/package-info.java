/** What an author wrote: immutable records one to one with the JSON, and the rules a level must keep. */
package nephele.engine.level;
