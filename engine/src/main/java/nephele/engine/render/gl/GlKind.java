package nephele.engine.render.gl;

/** Kinds of OpenGL objects that are counted. Programs are not counted: they belong to the context. */
public enum GlKind {
    BUFFER,
    VERTEX_ARRAY,
    TEXTURE,
    FRAMEBUFFER,
    RENDERBUFFER,
    QUERY
}
