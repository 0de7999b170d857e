package nephele.scenes.fixed;

import nephele.engine.asset.Picture;
import nephele.engine.model.Mesh;
import nephele.scenes.xml.XmlModel;

/** Provides a scene's meshes and pictures; an implementation has already warned about missing ones. */
public interface SceneFiles {
    /** Returns the mesh of a model; {@code null} if there is none to show. */
    Mesh mesh(XmlModel model);

    /** Returns the picture of a model that names one; {@code null} if there is none to show. */
    Picture picture(XmlModel model);
}
