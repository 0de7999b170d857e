package nephele.engine.render.gl;

import static org.lwjgl.opengl.GL41C.*;

import org.lwjgl.opengl.GL;
import org.lwjgl.opengl.GLCapabilities;

/**
 * Capabilities of this context beyond the 4.1 floor, queried once.
 *
 * @param maxAnisotropy 1 without anisotropic filtering
 * @param software true on CPU rasterisers, where GPU timer queries do not measure the work
 */
public record GpuLimits(
        String renderer,
        String version,
        float maxAnisotropy,
        boolean debugMessages,
        int maxTextureSize,
        int maxArrayLayers,
        int maxVolumeSize,
        int maxBufferTexels,
        int maxSamples,
        boolean software) {
    private static final int MAX_TEXTURE_MAX_ANISOTROPY = 0x84FF;

    /**
     * Queries the current context.
     *
     * @throws GlUnavailableException if it is below 4.1
     */
    static GpuLimits ofCurrent() {
        GLCapabilities can = GL.getCapabilities();
        String version = glGetString(GL_VERSION);
        String renderer = glGetString(GL_RENDERER);
        if (!can.OpenGL41) {
            throw new GlUnavailableException("OpenGL 4.1 is required; found " + version + " on " + renderer
                    + ". Update the graphics driver, or run with LIBGL_ALWAYS_SOFTWARE=1 to use Mesa's rasteriser.");
        }
        boolean anisotropic = can.GL_EXT_texture_filter_anisotropic || can.GL_ARB_texture_filter_anisotropic;
        return new GpuLimits(
                renderer,
                version,
                anisotropic ? glGetFloat(MAX_TEXTURE_MAX_ANISOTROPY) : 1,
                can.GL_KHR_debug,
                glGetInteger(GL_MAX_TEXTURE_SIZE),
                glGetInteger(GL_MAX_ARRAY_TEXTURE_LAYERS),
                glGetInteger(GL_MAX_3D_TEXTURE_SIZE),
                glGetInteger(GL_MAX_TEXTURE_BUFFER_SIZE),
                glGetInteger(GL_MAX_SAMPLES),
                renderer.contains("llvmpipe") || renderer.contains("softpipe") || renderer.contains("SWR"));
    }
}
