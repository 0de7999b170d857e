package nephele.scenes.fixed;

/** The shading of triangles; back faces are never drawn. */
public enum Shading {
    /** White edges a pixel wide; faces hide nothing. */
    WIREFRAME,
    /** Lit at each triangle's last vertex. */
    FLAT,
    /** Lit at the vertices, as fixed-function OpenGL does. */
    GOURAUD,
    /** Lit at the pixels. */
    PHONG
}
