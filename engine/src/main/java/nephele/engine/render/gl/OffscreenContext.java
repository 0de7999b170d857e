package nephele.engine.render.gl;

import static org.lwjgl.egl.EGL15.*;

import java.nio.IntBuffer;
import org.lwjgl.PointerBuffer;
import org.lwjgl.egl.EGL;
import org.lwjgl.system.JNI;
import org.lwjgl.system.MemoryStack;

/** EGL on Mesa's surfaceless platform: OpenGL without X or a GPU. */
record OffscreenContext(long display, long context) {
    private static final int PLATFORM_SURFACELESS_MESA = 0x31DD;
    private static final String REMEDY =
            " Install Mesa's EGL and OpenGL (Debian: apt-get install libegl1 libgl1 libgl1-mesa-dri).";

    static OffscreenContext makeCurrent() {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            long display = openDisplay(stack);
            EGL.createDisplayCapabilities(display);
            eglBindAPI(EGL_OPENGL_API);
            long context = eglCreateContext(display, chooseConfig(stack, display), 0L, stack.ints(contextAttributes()));
            if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
                throw new GlUnavailableException("An offscreen OpenGL 4.1 core context is required; EGL error 0x"
                        + Integer.toHexString(eglGetError()) + "." + REMEDY);
            }
            return new OffscreenContext(display, context);
        }
    }

    private static int[] contextAttributes() {
        return new int[] {
            EGL_CONTEXT_MAJOR_VERSION,
            4,
            EGL_CONTEXT_MINOR_VERSION,
            1,
            EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
            EGL_NONE
        };
    }

    private static long openDisplay(MemoryStack stack) {
        long getPlatformDisplay = getPlatformDisplay();
        // LWJGL's own wrapper rejects the default display, whose handle is 0.
        long display = JNI.callPPP(PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, 0L, getPlatformDisplay);
        IntBuffer version = stack.mallocInt(2);
        if (display == EGL_NO_DISPLAY || !eglInitialize(display, version.slice(0, 1), version.slice(1, 1))) {
            throw new GlUnavailableException(
                    "Offscreen rendering requires EGL's surfaceless platform; it is not there." + REMEDY);
        }
        return display;
    }

    private static long getPlatformDisplay() {
        try {
            long address = EGL.getFunctionProvider().getFunctionAddress("eglGetPlatformDisplay");
            if (address != 0) {
                return address;
            }
        } catch (UnsatisfiedLinkError e) {
            throw new GlUnavailableException("Offscreen rendering requires libEGL; it is not there." + REMEDY);
        }
        throw new GlUnavailableException("Offscreen rendering requires EGL 1.5; found an older one." + REMEDY);
    }

    private static long chooseConfig(MemoryStack stack, long display) {
        IntBuffer wanted = stack.ints(EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE);
        PointerBuffer config = stack.mallocPointer(1);
        IntBuffer count = stack.mallocInt(1);
        if (!eglChooseConfig(display, wanted, config, count) || count.get(0) == 0) {
            throw new GlUnavailableException("EGL offers no configuration for desktop OpenGL." + REMEDY);
        }
        return config.get(0);
    }

    /** Destroys the context. The display stays initialised: EGL shares it between all contexts of the process. */
    void destroy() {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
    }
}
