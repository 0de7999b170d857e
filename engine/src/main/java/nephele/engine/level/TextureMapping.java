package nephele.engine.level;

/** WORLD: repeats every {@code textureMetres} from the world's origin, so neighbours join; FACE: once over each face. */
public enum TextureMapping {
    WORLD,
    FACE
}
