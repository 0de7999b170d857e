package nephele.engine.render.pass.dynamic;

/** How things join what is behind them. */
enum DynamicBlending {
    SOLID,
    /** Lets through what is behind, but for edges: {@code held-look.glsl}. */
    SEE_THROUGH
}
