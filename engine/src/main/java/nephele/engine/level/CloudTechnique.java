package nephele.engine.level;

/** How a cloud is drawn; AUTO leaves the choice to the engine. */
public enum CloudTechnique {
    AUTO,
    SKYBOX,
    SKYPLANE,
    PROCEDURAL,
    BILLBOARD,
    PARTICLES,
    VOLUME
}
