/** Scenes as courses write them in XML, in two dialects: read leniently, posed at a time, converted to levels. */
package nephele.scenes.xml;
