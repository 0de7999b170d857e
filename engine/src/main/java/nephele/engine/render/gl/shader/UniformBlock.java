package nephele.engine.render.gl.shader;

/** The uniform blocks that several programs read, with their names in GLSL. The ordinal of each is its binding point. */
public enum UniformBlock {
    FRAME("Frame"),
    MATERIALS("Materials"),
    DYNAMIC_SHADE("DynamicShade"),
    LIGHT("Light"),
    CONTACT("Contact");

    private final String block;

    UniformBlock(String block) {
        this.block = block;
    }

    public int binding() {
        return ordinal();
    }

    /** Returns the block's name in GLSL. */
    String inShaders() {
        return block;
    }
}
