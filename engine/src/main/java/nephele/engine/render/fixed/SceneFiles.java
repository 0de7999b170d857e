package nephele.engine.render.fixed;

import nephele.engine.asset.Picture;
import nephele.engine.model.Mesh;
import nephele.engine.xmlscene.XmlModel;

/** Where a scene's meshes and pictures come from; what is missing has been complained of by whoever answers. */
public interface SceneFiles {
    /** The mesh of a model; {@code null} where there is none to show. */
    Mesh mesh(XmlModel model);

    /** The picture of a model that names one; {@code null} where there is none to show. */
    Picture picture(XmlModel model);
}
