package nephele.scenes.xml;

/** The dialect of a scene, which its root element states. */
public enum Dialect {
    /** {@code <scene>}: the dialect of the scene-engine report. */
    SCENE,
    /** {@code <world>}: the later dialect of the course. */
    WORLD
}
