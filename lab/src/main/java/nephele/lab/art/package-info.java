/** Everything that is drawn, painted by code: textures, skies, and the levels that are generated. */
package nephele.lab.art;
