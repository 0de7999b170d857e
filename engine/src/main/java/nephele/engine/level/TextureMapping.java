package nephele.engine.level;

/**
 * Mapping of a texture. WORLD repeats it every {@code textureMetres} from the world's origin, so it continues on
 * adjacent faces; FACE stretches it once over each face.
 */
public enum TextureMapping {
    WORLD,
    FACE
}
