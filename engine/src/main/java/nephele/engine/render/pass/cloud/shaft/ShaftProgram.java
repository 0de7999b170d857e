package nephele.engine.render.pass.cloud.shaft;

import java.util.List;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.cells.SlantedShade;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.ShaftClouds;
import nephele.engine.level.appearance.ShaftLight;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.pass.cloud.CloudUniforms;

/** {@code shaft.frag} with its numbers. */
final class ShaftProgram {
    private static final String FOLDER = "/nephele/engine/render/pass/cloud/shaft/";

    private final GlProgram<Places> program;

    /**
     * An eye in the space of the shade.
     *
     * @param focus of the boxes, relative to the eye
     */
    record Eye(Vec3 place, Vec3 focus) {}

    private record Places(CloudUniforms.Boxes boxes, Uniforms.Vector3 slant, Uniforms.Vector2 planet) {}

    ShaftProgram(LoadContext context) {
        var defines = Defines.of(context).with("MOST_BOXES", ShaftClouds.LEVELS).values();
        program = GlProgram.of(context.gl(), FOLDER + "shaft.vert", FOLDER + "shaft.frag", defines, Places.class);
    }

    void use(CloudInterval now, ShaftClouds clouds, ShaftLight light, Eye eye) {
        program.use();
        Places places = program.uniforms();
        List<CellBox> boxes = now.from().shade().boxes();
        for (int level = 0; level < boxes.size(); level++) {
            places.boxes.put(level, boxes.get(level).box(), eye.place());
        }
        CellBox narrowest = boxes.get(0);
        places.boxes.cells().set(narrowest.ny(), 0, boxes.size(), now.share());
        double reach = clouds.grid().reach() * narrowest.sizeX();
        places.boxes.put(narrowest.box(), eye.place(), eye.focus(), reach, reach);
        Vec3 slant = SlantedShade.slant(light.towards());
        places.slant.set(slant.x(), slant.z(), light.strength());
        places.planet.set(clouds.halfCurvature(), eye.place().y());
    }
}
