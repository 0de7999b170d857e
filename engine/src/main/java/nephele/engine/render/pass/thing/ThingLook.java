package nephele.engine.render.pass.thing;

/** How things join what is behind them. */
enum ThingLook {
    SOLID,
    /** Lets through what is behind, but for edges: {@code held-look.glsl}. */
    SEE_THROUGH
}
