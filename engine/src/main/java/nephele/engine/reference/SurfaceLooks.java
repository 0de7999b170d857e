package nephele.engine.reference;

/** What everything that rays meet is made of. */
record SurfaceLooks(Surfaces solids, BodySurfaces bodies, Skins skins) {}
