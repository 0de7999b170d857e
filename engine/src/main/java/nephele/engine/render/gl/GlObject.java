package nephele.engine.render.gl;

/** What holds OpenGL objects until it is closed, once, by its one owner. */
public interface GlObject extends AutoCloseable {
    @Override
    void close();
}
