package nephele.engine.render.gl;

/** Kinds of OpenGL objects that are counted. */
public enum GlKind {
    PROGRAM,
    BUFFER,
    VERTEX_ARRAY,
    TEXTURE,
    FRAMEBUFFER,
    RENDERBUFFER,
    QUERY
}
