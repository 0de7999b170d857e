package nephele.engine.render.gl.shader;

/** Thrown if OpenGL rejects an operation; the message names the object. */
public final class GlException extends RuntimeException {
    public GlException(String message) {
        super(message);
    }
}
