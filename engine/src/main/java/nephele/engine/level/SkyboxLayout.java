package nephele.engine.level;

/**
 * The arrangement of a skybox in its files: one unfolded cross, or six square pictures whose order and orientation are
 * this engine's, those of OpenGL's cube textures, those of Quake II, or those of pictures rendered with Terragen.
 */
public enum SkyboxLayout {
    FACES,
    CROSS,
    OPENGL,
    QUAKE2,
    TERRAGEN
}
