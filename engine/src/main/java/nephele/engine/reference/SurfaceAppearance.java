package nephele.engine.reference;

/** The materials of all items. */
record SurfaceAppearance(FaceMaterials solids, BodySurfaces bodies, MaterialTextures textures) {}
