package nephele.engine.reference;

/** The materials of all items. */
record SurfaceLooks(Surfaces solids, BodySurfaces bodies, Skins skins) {}
