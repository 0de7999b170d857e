package nephele.engine.render.fixed;

/** What becomes of triangles; their back faces are never drawn. */
public enum Shading {
    /** White edges a pixel wide; a face hides nothing. */
    WIREFRAME,
    /** Lit at each triangle's last vertex. */
    FLAT,
    /** Lit at the vertices, as fixed-function OpenGL does it. */
    GOURAUD,
    /** Lit at the pixels. */
    PHONG
}
