package nephele.engine.level;

/** The arrangement of a skybox in its files: six square faces, or one unfolded cross. */
public enum SkyboxLayout {
    FACES,
    CROSS
}
