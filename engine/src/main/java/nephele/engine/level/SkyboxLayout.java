package nephele.engine.level;

/** How a skybox lies in its files: six square faces, or one unfolded cross. */
public enum SkyboxLayout {
    FACES,
    CROSS
}
