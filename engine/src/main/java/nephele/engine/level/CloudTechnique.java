package nephele.engine.level;

/** The technique that draws a cloud; AUTO leaves the choice to the engine. */
public enum CloudTechnique {
    AUTO,
    SKYBOX,
    SKYPLANE,
    PROCEDURAL,
    BILLBOARD,
    PARTICLES,
    VOLUME
}
