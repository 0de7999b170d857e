package nephele.engine.xmlscene;

/** Which of the two languages a scene is written in; its root says so. */
public enum Dialect {
    /** {@code <scene>}: the scene-engine report's. */
    SCENE,
    /** {@code <world>}: the course's later one. */
    WORLD
}
