// Style sheets are imported for their effect: vite writes them to a file of their own.
declare module "*.css";
