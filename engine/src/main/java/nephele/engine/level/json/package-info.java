/**
 * The JSON format of levels and other files: a parser that keeps line and path of every value, one format per record
 * that reads and writes it, the schema that follows from the formats, and saving that never leaves a partial file.
 */
package nephele.engine.level.json;
