package nephele.engine.render.gl.shader;

/** OpenGL refused something; the message names the object. */
public final class GlException extends RuntimeException {
    public GlException(String message) {
        super(message);
    }
}
