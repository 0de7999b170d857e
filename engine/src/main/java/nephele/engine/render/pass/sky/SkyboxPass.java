package nephele.engine.render.pass.sky;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.util.List;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.level.appearance.SkyboxPictures;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.RenderFeature.Role;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.GpuMesh;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.VertexFormat;
import nephele.engine.render.gl.VertexFormat.Attribute;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms.Scalar;
import nephele.engine.render.resource.PictureArrays;
import org.joml.Vector3d;

/** Draws six pictures around the eye where no solid has been drawn. Fog hides them. */
public final class SkyboxPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "sky.skybox", Stage.IN_VIEWS, Role.SKY, SkyboxPass::requiredBy)
            .using(PictureArrays.DECODED);

    private static final String FOLDER = "/nephele/engine/render/pass/sky/";
    private static final int[][] CORNERS = {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}};
    private static final int[] QUAD = {0, 1, 2, 0, 2, 3};

    private final GlContext gl;
    private final GlProgram<Scalar> program;
    private final float whiteRadiance;
    private final Texture faces;
    private final GpuMesh mesh;

    private SkyboxPass(LoadContext context, Sky.Skybox sky) {
        gl = context.gl();
        faces = context.share(
                Texture.class,
                List.of(context.openedLevel(), sky, context.output()),
                () -> SkyboxCube.upload(context, SkyboxPictures.of(sky, context.get(PictureArrays.DECODED))));
        mesh = context.own(mesh(gl, faces.extent().width()));
        whiteRadiance = (float) sky.whiteRadiance();
        var defines = Defines.of(context).values();
        program = GlProgram.of(
                gl,
                FOLDER + "skybox.vert",
                FOLDER + "skybox.frag",
                defines,
                uniforms -> uniforms.scalar("whiteRadiance"));
    }

    private static List<Required> requiredBy(FrameRequest request) {
        Environment environment = request.level().environment();
        boolean isVisible = !FogTransmittance.hidesSky(environment);
        return isVisible && environment.sky() instanceof Sky.Skybox skybox
                ? List.of(new Required("environment.sky: a skybox", context -> new SkyboxPass(context, skybox)))
                : List.of();
    }

    /** Returns a cube around the eye. @param side texels of a layer, with its border */
    private static GpuMesh mesh(GlContext gl, int side) {
        ByteBuffer vertices = ByteBuffer.allocateDirect(6 * 4 * 24).order(ByteOrder.nativeOrder());
        IntBuffer indices = ByteBuffer.allocateDirect(6 * 6 * 4)
                .order(ByteOrder.nativeOrder())
                .asIntBuffer();
        for (int face = 0; face < 6; face++) {
            for (int[] corner : CORNERS) {
                Vector3d p = SkyboxCube.point(face, corner[0], corner[1]);
                vertices.putFloat((float) p.x).putFloat((float) p.y).putFloat((float) p.z);
                vertices.putFloat(insideBorder(corner[0], side)).putFloat(insideBorder(corner[1], side));
                vertices.putFloat(face);
            }
            for (int i : QUAD) {
                indices.put(4 * face + i);
            }
        }
        VertexFormat format = VertexFormat.of(Attribute.FLOAT3, Attribute.FLOAT3);
        return new GpuMesh(gl, "skybox", format, vertices.flip(), indices.flip());
    }

    /** Converts −1 and 1 to the texture coordinates of a layer without its border. */
    private static float insideBorder(int corner, int side) {
        return corner < 0 ? 1f / side : (side - 1f) / side;
    }

    @Override
    public void draw(FrameContext frame) {
        frame.surface().bind();
        gl.state().set(Depth.LESS_OR_EQUAL, Blend.REPLACE, Cull.NONE);
        program.use();
        program.uniforms().set(whiteRadiance);
        faces.bind(TextureUnit.COLOURS);
        mesh.draw(0, 36);
    }
}
