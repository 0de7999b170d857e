/** Scenes as courses write them in XML, in two dialects: read forgivingly, placed at a time, turned into levels. */
package nephele.engine.xmlscene;
