package nephele.engine.render.pass.rim;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.portal.Aperture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;

/** One shape for each kind of aperture, created when the first portal of its kind is drawn. */
final class RimShapes implements GlObject {
    private final GlContext gl;
    private final List<RimShape> shapes = new ArrayList<>();

    RimShapes(GlContext gl) {
        this.gl = gl;
    }

    RimShape of(Aperture aperture) {
        for (int i = 0; i < shapes.size(); i++) {
            if (shapes.get(i).isOf(aperture)) {
                return shapes.get(i);
            }
        }
        RimShape made = new RimShape(gl, aperture);
        shapes.add(made);
        return made;
    }

    @Override
    public void close() {
        shapes.forEach(RimShape::close);
    }
}
