/** Text, panels and the crosshair over the picture: a generated stroke font, its distance field and one draw. */
package nephele.engine.render.pass.overlay;
