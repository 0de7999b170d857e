package nephele.engine.render.gl;

/** An owner of OpenGL objects, which its own owner closes exactly once. */
public interface GlObject extends AutoCloseable {
    @Override
    void close();
}
